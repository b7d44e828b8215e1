'use strict';
// A click on a column's head sorts the table; a second click turns the order round.
for (const button of document.querySelectorAll('th button'))
    button.addEventListener('click', () => {
        const head = button.closest('th'), body = head.closest('table').tBodies[0];
        const down = head.getAttribute('aria-sort') === 'ascending', column = head.cellIndex;
        const key = (row) => row.cells[column].dataset.key ?? row.cells[column].textContent;
        const numbers = head.classList.contains('number');
        const compare = (a, b) => (numbers ? key(a) - key(b) : key(a) < key(b) ? -1 : key(a) > key(b) ? 1 : 0);
        for (const other of head.parentElement.cells) other.removeAttribute('aria-sort');
        head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
        body.append(...[...body.rows].sort((a, b) => (down ? compare(b, a) : compare(a, b))));
    });

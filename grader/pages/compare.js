'use strict';
// The slider over two pictures: left of the line the first, right of it the second. `data-compare` names them: "yours|reference".
// Without this script half of each is seen, or both side by side.
for (const slider of document.querySelectorAll('input[data-compare]')) {
    const [first, second] = slider.dataset.compare.split('|'), pictures = slider.previousElementSibling;
    const show = () => {
        pictures.style.setProperty('--at', slider.value + '%');
        slider.setAttribute('aria-valuetext', `${slider.value} % ${first}, ${100 - slider.value} % ${second}`);
    };
    pictures.classList.add('compare');
    slider.hidden = false;
    slider.addEventListener('input', show);
    show();
}

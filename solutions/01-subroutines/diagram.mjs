// The diagram of lab 01: the array that sets all pointers, the pointers, and the functions.
const row = 34;

function table(s, x, y, wide, title, rows) {
  s.text([x, y + 14], title, "e", "quiet", -10);
  rows.forEach(([number, name], i) => {
    const top = y - i * row;
    s.box([x, top - row], [x + wide, top], "open");
    s.line([x + 38, top - row], [x + 38, top], "faint");
    s.text([x + 19, top - row / 2], String(number), "c", "quiet");
    s.text([x + 48, top - row / 2], name, "e", "", -10);
  });
}

function draw(s) {
  const array = [[0, "3"], [1, "1"]], pointers = [[0, "u_finish"], [1, "u_shade"]];
  const functions = [[0, "shade_ambient"], [1, "shade_diffuse"], [2, "finish_plain"], [3, "finish_posterised"]];
  const tall = 196;
  table(s, 16, tall, 120, "your array", array);
  table(s, 190, tall, 150, "location: pointer", pointers);
  table(s, 420, tall, 204, "index: function", functions);
  const middle = (i) => tall - i * row - row / 2;
  for (const [i, [, index]] of array.entries()) {
    s.arrow([136, middle(i)], [188, middle(i)], "mark");
    s.arrow([340, middle(i)], [418, middle(Number(index))], "mark");
  }
  s.text([16, 96], "Entry *l* is for location *l*.", "e", "", -10);
  s.text([16, 72], "What stands in it is an index.", "e", "", -10);
  s.text([16, 36], "The numbers are the driver's: ask for them by name.", "e", "quiet", -10);
}

export const diagrams = [{
  name: "pointers", width: 640, height: 236, draw,
  title: "Locations and indices",
  text: "An array with two entries: entry 0 holds 3, entry 1 holds 1. Entry 0 is for the pointer u_finish at the location 0, entry 1 for u_shade at the location 1. So u_finish points " +
    "to the function with the index 3, finish_posterised, and u_shade to the function with the index 1, shade_diffuse. The numbers are the driver's choice.",
}];

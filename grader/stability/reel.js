// A slider goes through the frames of a row's sweep.
for (const reel of document.querySelectorAll('.reel')) {
  const frames = JSON.parse(reel.querySelector('script').textContent), slider = reel.querySelector('input'),
        picture = reel.querySelector('img'), caption = reel.querySelector('figcaption');
  const show = () => {
    const [words, bytes] = frames[slider.value];
    picture.src = ['data:image/png', 'base64,'].join(';') + bytes;
    picture.alt = `The method, the truth and the error: ${words}`;
    caption.textContent = `${Number(slider.value) + 1} of ${frames.length}: ${words}`;
    slider.setAttribute('aria-valuetext', caption.textContent);
  };
  slider.addEventListener('input', show);
  slider.value = 0;
  show();
  reel.hidden = false;
}

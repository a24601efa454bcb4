// The modes of the bodies: their kinds and their pictures.

/// @param modes  as the program writes them (src/study/report/page_modes.cpp)
function showModes({bodies, notes}) {
  element("modes-section").hidden = !bodies.length && !notes.length;
  const texts = bodies.filter(({left_out: count}) => count).map(({body, left_out: count}) =>
    `${count} modes of ${body} have no picture: it has too many triangles.`);
  element("modes-note").textContent = [...notes, ...texts].join(" ");
  element("modes").replaceChildren(...bodies.flatMap(({body, modes}) => modes.map((mode, index) => modeFigure(body, mode, index + 1))));
}

function modeFigure(body, {frequency, decay_time: decay, mesh_error: error, kind, picture}, number) {
  const figure = document.createElement("figure"), caption = document.createElement("figcaption");
  caption.textContent = `${body} ${number}: ${fixed(frequency, 2)} Hz` + (kind ? `, ${kind}` : "") +
    (decay === null ? "" : `, T60 ${fixed(decay, 3)} s`) +
    (error === null ? "" : `, mesh error ${fixed(error, 1)} cents`);
  if (picture) {
    const image = document.createElement("img");
    image.src = URL.createObjectURL(new Blob([picture], {type: "image/svg+xml"}));
    image.alt = `Shape of mode ${number} of ${body}: red moves outwards, blue inwards`;
    image.loading = "lazy";
    figure.append(image);
  }
  figure.append(caption);
  return figure;
}

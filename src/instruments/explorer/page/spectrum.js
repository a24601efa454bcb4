// The spectrum of what is heard, with the modes of the chosen body.

/// @param analyser     of Web Audio, or nothing before the first sound
/// @param frequencies  of the marks, Hz
function drawSpectrum(canvas, analyser, frequencies) {
  const pen = canvas.getContext("2d"), {width, height} = canvas, top = 20000, bottom = 40;
  const x = hertz => width * Math.log(hertz / bottom) / Math.log(top / bottom);
  pen.clearRect(0, 0, width, height);
  pen.strokeStyle = "#ccc";
  pen.fillStyle = "#555";
  for (const [hertz, label] of [[100, "100 Hz"], [1000, "1 kHz"], [10000, "10 kHz"]]) {
    pen.strokeRect(x(hertz), 0, 0, height);
    pen.fillText(label, x(hertz) + 3, 10);
  }
  pen.fillStyle = "#b33";
  for (const hertz of frequencies) pen.fillRect(x(hertz), height - 6, 1, 6);
  if (!analyser) return;
  const levels = new Float32Array(analyser.frequencyBinCount);
  analyser.getFloatFrequencyData(levels);
  pen.strokeStyle = "#246";
  pen.beginPath();
  levels.forEach((level, bin) => {
    const hertz = bin * analyser.context.sampleRate / analyser.fftSize;
    if (hertz >= bottom) pen.lineTo(x(hertz), height * Math.min(1, -Math.max(level, -140) / 140));
  });
  pen.stroke();
}

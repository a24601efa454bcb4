// node speed.mjs PAGE: opens a Sonic Explorer in Chromium without a window, and prints as JSON how many modes that ring a core
// computes in real time, by JavaScript and by WebAssembly, for one channel and for two: [{channels, javascript, webassembly}].
import {openExplorer} from "./browser.mjs";

const {browser, page} = await openExplorer(process.argv[2], 800, 500);
const speeds = await page.evaluate(() => {
  const rate = 48000, count = 1024, block = 128;
  const ringing = (channels, make) => {
    const pressure = Array.from({length: channels}, () => new Float64Array(2 * count).fill(1));
    const frequency = Float64Array.from({length: count}, (_, mode) => 100 + 20 * mode), decay = new Float64Array(count).fill(1);
    const modes = make({frequency, decay, pressure}), one = Float64Array.of(1);
    modes.strike({start: 0, force: {mean: one, slope: one, begin: one}, participation: new Float64Array(count).fill(1)});
    let now = 0;
    return () => {  // how many of these modes would take as long as they sound, in a time in which hardly anybody interrupts
      const begin = performance.now(), first = now;
      for (; performance.now() < begin + 10; now += block) modes.render(now, block);
      return count * (now - first) / rate * 1000 / (performance.now() - begin);
    };
  };
  return [1, 2].map(channels => {
    const javascript = ringing(channels, tuning => new Modes(tuning, rate));
    const webassembly = ringing(channels, tuning => new CompiledModes(compiledCode(compiledBytes), tuning, rate));
    const best = {channels, javascript: 0, webassembly: 0};
    for (let round = 0; round < 200; ++round) {  // in turns
      best.javascript = Math.max(best.javascript, javascript());
      best.webassembly = Math.max(best.webassembly, webassembly());
    }
    return best;
  });
});
await browser.close();
console.log(JSON.stringify(speeds));

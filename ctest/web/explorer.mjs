// node explorer.mjs PAGE BLOW SCREENSHOT: opens the Sonic Explorer in Chromium without a window, strikes what is in the
// middle by a click and by a key, as modes and as proxies at two levels, renders a blow as modes, with and without WebAssembly,
// and as a proxy of level 1 with twice the tension, and prints what happened as JSON.
import {openExplorer} from "./browser.mjs";

const [page_file, blow, screenshot] = process.argv.slice(2);

const {browser, page, complaints} = await openExplorer(page_file, 1200, 760);

const room = await page.locator("#room").boundingBox();
await page.mouse.click(room.x + room.width / 2, room.y + room.height / 2);
await page.waitForFunction(() => window.idiophone.explorer.strikes === 1);
const said = await page.locator("#blow").textContent();
await page.locator("#room").press("Enter");
await page.waitForFunction(() => window.idiophone.explorer.strikes === 2);
await page.locator("#mode").press("ArrowRight");
const mode = await page.locator("#mode-text").textContent();

const sound = await page.evaluate(({blows, duration, rate}) => window.idiophone.renderOffline(blows, duration, rate),
                                  JSON.parse(blow));
const javascript = await page.evaluate(({blows, duration, rate}) => window.idiophone.renderOffline(blows, duration, rate, null),
                                       JSON.parse(blow));
await page.locator("#model").selectOption("0");  // a proxy, while the modes still sound
await page.locator("#room").press("Enter");
await page.waitForFunction(() => window.idiophone.explorer.strikes === 3);
await page.locator("#tension").fill("1");
await page.locator("#friction").fill("0.5");
await page.locator("#model").selectOption("1");
await page.locator("#room").press("Enter");
await page.waitForFunction(() => window.idiophone.explorer.strikes === 4);
const proxy = await page.evaluate(({blows, duration, rate}) => window.idiophone.renderOffline(blows, duration, rate),
                                  JSON.parse(blow));
await page.locator("#model").selectOption("");

const rate = await page.evaluate(async () => {  // of a grid of 200 000 triangles that swings, drawn without a graphics card
  const cells = 316, vertices = [], triangles = [];
  for (let i = 0; i <= cells; ++i) for (let j = 0; j <= cells; ++j) vertices.push(i / cells, j / cells, 0);
  for (let i = 0; i < cells; ++i) {
    for (let j = 0; j < cells; ++j) {
      const a = i * (cells + 1) + j, b = a + cells + 1;
      triangles.push(a, b, b + 1, a, b + 1, a + 1);
    }
  }
  const body = {vertices: new Float32Array(vertices), triangles: new Uint32Array(triangles),
                shape: new Int16Array(vertices.length).fill(1000)};
  const canvas = document.createElement("canvas");
  canvas.style = "position: fixed; width: 800px; height: 600px";
  document.body.append(canvas);
  const view = new View(canvas, [body]);
  view.show({body: 0, mode: 0});
  const pixel = new Uint8Array(4);
  const pictures = (count, draw) => {  // ms each, and of them those of the script
    let script = 0;
    const start = performance.now();
    for (let n = 0; n < count; ++n) {
      const begin = performance.now();
      draw(n);
      script += performance.now() - begin;
      view.gl.readPixels(0, 0, 1, 1, view.gl.RGBA, view.gl.UNSIGNED_BYTE, pixel);  // waits for the picture
    }
    return {all: (performance.now() - start) / count, script: script / count};
  };
  const still = pictures(5, n => view.draw(n / 30, 0));
  pictures(20, () => view.animate(performance.now(), 0));  // it finds its pace
  const moving = pictures(60, () => view.animate(performance.now(), 0));
  canvas.remove();
  return {triangles: body.triangles.length / 3, still, moving, level: view.pace.level};
});
await page.setViewportSize({width: 390, height: 760});  // a phone
const narrow = await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth);
await page.setViewportSize({width: 1200, height: 760});
await page.screenshot({path: screenshot});
await browser.close();
console.log(JSON.stringify({complaints, said, mode, sound, javascript, proxy, rate, narrow}));

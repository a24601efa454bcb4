// Rules for the web pages' scripts and the tests that drive a browser.
import {readdirSync, readFileSync} from "node:fs";
import {load} from "./modules.mjs";

const js = load("@eslint/js");
const globals = load("globals");

const pages = "src/**/page/*.js";

/// The scripts of a page share their names: what a file declares at the beginning of a line, all may read.
function sharedNames() {
  const declared = /^(?:async )?(?:function|class|const|let) (\w+)/gm;
  const source = new URL("../../src/", import.meta.url);
  const texts = readdirSync(source, {recursive: true}).filter(file => /\/page\/\w+\.js$/.test(file))
    .map(file => readFileSync(new URL(file, source), "utf8"));
  return Object.fromEntries(texts.flatMap(text => [...text.matchAll(declared)]).map(([, name]) => [name, "readonly"]));
}

const rules = {
  "eqeqeq": "error",
  "no-shadow": "error",
  "no-unused-vars": ["error", {vars: "local"}],
  "no-redeclare": ["error", {builtinGlobals: false}],
  "no-var": "error",
  "prefer-const": "error",
};

export default [
  js.configs.recommended,
  {
    files: [pages],
    languageOptions: {sourceType: "script", globals: {...globals.browser, ...globals.audioWorklet, ...sharedNames()}},
    rules,
  },
  {files: ["**/*.mjs"], languageOptions: {globals: {...globals.node, ...globals.browser, ...sharedNames()}}, rules},
];

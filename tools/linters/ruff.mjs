// node ruff.mjs FILE ...: checks Python files by the rules of ruff.toml. Prints a line for each finding; status 1 if there are any.
import {readFileSync} from "node:fs";
import {load} from "./modules.mjs";

const {Workspace, PositionEncoding} = load("@astral-sh/ruff-wasm-nodejs");
const {parse} = load("smol-toml");

const rules = parse(readFileSync(new URL("../../ruff.toml", import.meta.url), "utf8"));
const workspace = new Workspace(rules, PositionEncoding.Utf8);
for (const file of process.argv.slice(2)) {
  for (const {code, message, start_location: {row, column}} of workspace.check(readFileSync(file, "utf8"))) {
    console.log(`${file}:${row}:${column}: ${code ?? "error"} ${message}`);
    process.exitCode = 1;
  }
}

// node gltf.mjs FILE...: what the glTF validator of Khronos finds in each file, as JSON: [{errors, warnings, messages}, ...].
import {readFile} from "node:fs/promises";
import {createRequire} from "node:module";

const validator = createRequire(`${process.env.WEB_MODULES}/`)("gltf-validator");

const reports = [];
for (const path of process.argv.slice(2)) {
  const {issues} = await validator.validateBytes(new Uint8Array(await readFile(path)), {uri: path});
  reports.push({errors: issues.numErrors, warnings: issues.numWarnings,
    messages: issues.messages.map(({code, message, pointer}) => `${code} ${pointer}: ${message}`)});
}
console.log(JSON.stringify(reports));

// The packages that tools/lint has installed: `load` is a require() that finds them.
import {createRequire} from "node:module";

export const load = createRequire(new URL("../../build/linters/", import.meta.url));

// SPDX-License-Identifier: Apache-2.0

// Checks all GLB files in a folder with the validator of Khronos. Usage: node meshes.mjs FOLDER. See meshes.sh.

import {readdirSync} from "node:fs";
import {join} from "node:path";
import {checkGlb} from "./scenes/gltf.mjs";

const folder = process.argv[2];
const files = readdirSync(folder).filter((name) => name.endsWith(".glb"));
for (const name of files) {
    await checkGlb(join(folder, name));
}
console.log(`${files.length} GLB files without a message of the validator`);
if (files.length === 0) {
    throw new Error("there are no GLB files");
}

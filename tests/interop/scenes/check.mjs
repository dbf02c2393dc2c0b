// SPDX-License-Identifier: Apache-2.0

// Reads the scene files in the folders of a folder, and checks them. Usage: node check.mjs FOLDER. See ../scenes.sh.

import {existsSync, readdirSync} from "node:fs";
import {dirname, join} from "node:path";
import {checkGlb} from "./gltf.mjs";
import {checkMtlx} from "./mtlx.mjs";
import {checkUsda} from "./usda.mjs";

const CHECKS = {usda: checkUsda, mtlx: checkMtlx, glb: checkGlb};

// Throws if a scene refers to a file that does not exist.
export function checkFiles(scene, files) {
    for (const file of files) {
        if (!existsSync(join(dirname(scene), file))) {
            throw new Error(`${scene}: '${file}' does not exist`);
        }
    }
}

const folder = process.argv[2];
const found = Object.fromEntries(Object.keys(CHECKS).map((suffix) => [suffix, 0]));
for (const name of readdirSync(folder, {recursive: true}).sort()) {
    const suffix = name.split(".").at(-1);
    if (CHECKS[suffix]) {
        checkFiles(join(folder, name), await CHECKS[suffix](join(folder, name)));
        ++found[suffix];
    }
}
console.log(Object.entries(found).map(([suffix, count]) => `${count} ${suffix}`).join(", "));
const expected = {usda: 14, mtlx: 15, glb: 15};
if (Object.keys(CHECKS).some((suffix) => found[suffix] !== expected[suffix])) {
    throw new Error(`there must be ${JSON.stringify(expected)}`);
}

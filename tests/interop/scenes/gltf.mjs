// SPDX-License-Identifier: Apache-2.0

// Checks binary files of glTF with the validator of Khronos.

import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {PACKAGES} from "./packages.mjs";

const validator = createRequire(import.meta.url)(`${PACKAGES}/gltf-validator`);

// Throws if the validator has any message. Returns no files, because the images are in the file itself.
export async function checkGlb(scene) {
    const report = await validator.validateBytes(new Uint8Array(readFileSync(scene)));
    if (report.issues.messages.length > 0 || report.info.drawCallCount !== 1) {
        throw new Error(`${scene}: ${JSON.stringify(report.issues.messages)}`);
    }
    return [];
}

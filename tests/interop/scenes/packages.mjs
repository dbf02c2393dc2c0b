// SPDX-License-Identifier: Apache-2.0

// The folder of the packages of npm, which samples/setup/node.sh installs.

import {dirname, resolve} from "node:path";
import {fileURLToPath} from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../../..");

export const PACKAGES = resolve(root, "build/npm/scenes/node_modules");

// SPDX-License-Identifier: Apache-2.0
//
// The packages of npm that samples/setup/node.sh has installed into build/npm.

import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const root = fileURLToPath(new URL("../../", import.meta.url));

// Returns the folder of a package, such as "three". `name` is the name of the folder that lists the package, such as
// "interop" for tests/interop/package.json.
export function package_folder(name, package_name) {
    return path.join(root, "build/npm", name, "node_modules", package_name);
}

// Imports a package. Returns its module.
export async function import_package(name, package_name) {
    const resolve = createRequire(path.join(root, "build/npm", name, "package.json")).resolve;
    return import(pathToFileURL(resolve(package_name)));
}

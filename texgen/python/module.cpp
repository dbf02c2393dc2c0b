// SPDX-License-Identifier: Apache-2.0

#include "texgen/python/bindings.h"

PYBIND11_MODULE(_foamtex, module) {
    module.doc() = "The compiled part of the package foamtex.";
    foam::texgen::bind_records(module);
    foam::texgen::bind_steps(module);
    foam::texgen::bind_foam(module);
    foam::texgen::bind_texture(module);
    foam::texgen::bind_files(module);
}

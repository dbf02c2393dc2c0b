# SPDX-License-Identifier: Apache-2.0

# Debian packages, which `cpack -G DEB` makes: foamtex (the program and the shared libraries), foamtex-dev (headers,
# static libraries, CMake package, pkg-config files) and python3-foamtex. samples/setup/debian_packages.sh calls it.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "foamtex maintainers")
set(CPACK_PACKAGE_CONTACT "foamtex maintainers <maintainers@foamtex.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL program libraries development python metadata)
foreach(component IN ITEMS program libraries)
  string(TOUPPER ${component} upper)
  set(CPACK_COMPONENT_${upper}_GROUP foamtex)
endforeach()
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(CPACK_COMPONENT_PYTHON_GROUP python)
set(CPACK_COMPONENT_METADATA_GROUP python)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(version ${PROJECT_VERSION})
# CPack indents the lines of a description, and makes paragraphs of empty lines.
set(text "foamtex makes seamlessly tileable, animated textures from a simulation
of a two-dimensional dry foam in mechanical equilibrium: colors, normals,
heights and other maps as PNG, OpenEXR, DDS or KTX2 files, drawings as SVG,
DXF or PDF, and meshes.")

set(CPACK_DEBIAN_FOAMTEX_PACKAGE_NAME foamtex)
set(CPACK_DEBIAN_FOAMTEX_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_FOAMTEX_DESCRIPTION "${text}

This package contains the program and the shared libraries.")
# The linker's cache learns of the shared libraries.
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/debian/control/triggers CONTENT "activate-noawait ldconfig
" @ONLY)
set(CPACK_DEBIAN_FOAMTEX_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/debian/control/triggers)
set(CPACK_DEBIAN_FOAMTEX_PACKAGE_SUGGESTS "python3-foamtex, gnuplot-nox, ffmpeg")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME foamtex-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${text}

This package contains the headers, the static libraries, and the files with
which CMake and pkg-config find them.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "foamtex (= ${version})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
  "libcairo2-dev, libdeflate-dev, libfmt-dev, libglu1-mesa-dev, libisal-dev, libopenexr-dev, libpng-dev, libpugixml-dev, libtomlplusplus-dev, libxxhash-dev, libzstd-dev")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-foamtex)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "${text}

This package contains the module foamtex for Python, which returns NumPy
arrays.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")

# dpkg compiles the Python files when they are installed, and removes what Python has compiled.
foreach(script IN ITEMS postinst prerm)
  set(command "py3compile")
  if(script STREQUAL "prerm")
    set(command "py3clean")
  endif()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/debian/control/${script} @ONLY
    CONTENT "#!/bin/sh\nset -e\nif command -v ${command} >/dev/null 2>&1; then\n    ${command} -p python3-foamtex\nfi\n")
  file(CHMOD ${CMAKE_CURRENT_BINARY_DIR}/debian/control/${script}
    PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  list(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/debian/control/${script})
endforeach()

# The Debian Policy requires a copyright file and a compressed changelog in each package. The option -n of gzip stores no
# time, so that the file is reproducible.
find_program(GZIP gzip)
if(GZIP)
  foreach(group IN ITEMS foamtex foamtex-dev python3-foamtex)
    set(component program)
    if(group STREQUAL "foamtex-dev")
      set(component development)
    elseif(group STREQUAL "python3-foamtex")
      set(component python)
    endif()
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/debian/${group})
    configure_file(${CMAKE_CURRENT_SOURCE_DIR}/debian/copyright ${folder}/copyright @ONLY)
    configure_file(${CMAKE_CURRENT_SOURCE_DIR}/debian/changelog ${folder}/changelog @ONLY)
    execute_process(COMMAND ${GZIP} -9nkf ${folder}/changelog)
    install(FILES ${folder}/copyright ${folder}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${group}
      COMPONENT ${component})
  endforeach()
endif()

set(CPACK_SOURCE_GENERATOR TGZ)
include(CPack)

# SPDX-License-Identifier: Apache-2.0

# Defines and installs the libraries foam_core and foam_texgen, shared and static. Also installs what other programs
# need to find them: headers, a CMake package and pkg-config files. samples/library shows how to use the libraries.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
find_package(Threads REQUIRED)

get_property(rooms GLOBAL PROPERTY FOAM_ROOMS)
set(core_rooms ${rooms})
list(FILTER core_rooms INCLUDE REGEX "^foam_core_")
set(texgen_rooms ${rooms})
list(FILTER texgen_rooms INCLUDE REGEX "^foam_texgen_")
# The command line and the studio belong to the program.
list(REMOVE_ITEM texgen_rooms foam_texgen_cli foam_texgen_studio)

set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})  # texgen/api/README.md

# foam_library(NAME HEADERS folder... SHARED target... STATIC room... LIBRARIES target...) creates the libraries
# foam_NAME_shared and foam_NAME_static. The shared library has the classes of the room foam_NAME_api, and exports
# nothing else; SHARED are the libraries that it links. The static library contains the objects of the rooms STATIC and
# needs the LIBRARIES.
function(foam_library name)
  cmake_parse_arguments(PARSE_ARGV 1 library "" "" "HEADERS;SHARED;STATIC;LIBRARIES")
  set(exports ${PROJECT_SOURCE_DIR}/texgen/api/exports.map)
  add_library(foam_${name}_shared SHARED $<TARGET_OBJECTS:foam_${name}_api>)
  target_link_libraries(foam_${name}_shared ${library_SHARED})
  target_link_options(foam_${name}_shared PRIVATE LINKER:--version-script=${exports} LINKER:--no-undefined)
  set_target_properties(foam_${name}_shared PROPERTIES
    LINK_DEPENDS ${exports} LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION} SOVERSION ${soversion} EXPORT_NAME ${name}
    INSTALL_RPATH $ORIGIN)  # each shared library finds the other one beside it

  set(objects ${library_STATIC})
  list(TRANSFORM objects REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
  add_library(foam_${name}_static STATIC ${objects})
  set_target_properties(foam_${name}_static PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${name}_static)
  target_link_libraries(foam_${name}_static PUBLIC ${library_LIBRARIES})

  foreach(kind IN ITEMS shared static)
    set_target_properties(foam_${name}_${kind} PROPERTIES OUTPUT_NAME foam_${name})
    target_compile_features(foam_${name}_${kind} INTERFACE cxx_std_20)
    target_include_directories(foam_${name}_${kind} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  endforeach()
  foreach(folder IN LISTS library_HEADERS)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/foamtex DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
      COMPONENT development)
  endforeach()
  install(TARGETS foam_${name}_shared EXPORT foamtex_${name}
    LIBRARY COMPONENT libraries NAMELINK_COMPONENT development)
  install(EXPORT foamtex_${name} NAMESPACE foam:: FILE foamtex-${name}.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/foamtex COMPONENT development)
  install(TARGETS foam_${name}_static EXPORT foamtex_${name}_static ARCHIVE COMPONENT development)
  install(EXPORT foamtex_${name}_static NAMESPACE foam:: FILE foamtex-${name}_static.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/foamtex COMPONENT development)
endfunction()

set(inner_core_rooms ${core_rooms})
list(REMOVE_ITEM inner_core_rooms foam_core_api)
set(inner_texgen_rooms ${texgen_rooms})
list(REMOVE_ITEM inner_texgen_rooms foam_texgen_api)
foam_library(core
  HEADERS core/library/public core/api/public
  SHARED PRIVATE ${inner_core_rooms}
  STATIC ${core_rooms}
  LIBRARIES fmt::fmt Threads::Threads)
foam_library(texgen
  HEADERS texgen/api/public
  SHARED PUBLIC foam_core_shared PRIVATE ${inner_texgen_rooms} ${inner_core_rooms}
  STATIC ${texgen_rooms}
  LIBRARIES
    foam_core_static PNG::PNG ZLIB::ZLIB OpenEXR::OpenEXR pugixml::pugixml PkgConfig::isal PkgConfig::deflate
    PkgConfig::xxhash PkgConfig::zstd PkgConfig::cairo PkgConfig::glu tomlplusplus::tomlplusplus)

set(packages ${CMAKE_CURRENT_BINARY_DIR}/packages)
configure_package_config_file(api/foamtexConfig.cmake.in ${packages}/foamtexConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/foamtex NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${packages}/foamtexConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${packages}/foamtexConfig.cmake ${packages}/foamtexConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/foamtex COMPONENT development)
# pkg-config finds the prefix from the place of its files, so that the installed folder may be moved.
file(RELATIVE_PATH FOAM_PREFIX_OF_PKGCONFIG /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
foreach(name IN ITEMS foam_core foam_texgen)
  configure_file(api/${name}.pc.in ${packages}/${name}.pc @ONLY)
  install(FILES ${packages}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/presets DESTINATION ${CMAKE_INSTALL_DATADIR}/foamtex
  COMPONENT program FILES_MATCHING PATTERN "*.toml")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# cmake --install: the public headers, libraries with their shaders inside, the host's shader include, packages for CMake
# and pkg-config, the program with its manual page and completion. Nothing in it names the place where it is installed.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# What a host may include, and what that includes, as in src/. Installed below limpid/, so that no name of theirs meets
# another library's.
set(LIMPID_PUBLIC_HEADERS
  limpid/Caustics.h limpid/Context.h
  core/Bounds.h core/Error.h core/Picture.h
  scene/HeightField.h scene/HostMesh.h scene/HostWater.h scene/Mesh.h scene/Model.h scene/Scene.h scene/Sea.h scene/Shapes.h scene/Spectrum.h
  io/bake/BakedFolder.h io/gltf/Gltf.h io/images/HeightImages.h io/images/Images.h io/NamePatterns.h io/toml/SceneFile.h)
set(LIMPID_LIBRARIES limpid-scene limpid-core limpid-io limpid)
set(LIMPID_COMPONENTS scene core io limpid)
if(LIMPID_REFERENCE)
  list(APPEND LIMPID_PUBLIC_HEADERS reference/Truth.h)
  list(APPEND LIMPID_LIBRARIES limpid-reference)
  list(APPEND LIMPID_COMPONENTS reference)
endif()
if(LIMPID_VIEWER)
  list(APPEND LIMPID_PUBLIC_HEADERS apps/viewer/Viewer.h io/toml/SceneDocument.h)
  list(APPEND LIMPID_LIBRARIES limpid-viewer)
  list(APPEND LIMPID_COMPONENTS viewer)
endif()

set(headers ${CMAKE_BINARY_DIR}/generated/include)
install(CODE "execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${CMAKE_SOURCE_DIR}/src -DOUTPUT=${headers}
  \"-DHEADERS=${LIMPID_PUBLIC_HEADERS}\" -P ${CMAKE_SOURCE_DIR}/cmake/WritePublicHeaders.cmake COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${headers}/limpid DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

foreach(library ${LIMPID_LIBRARIES})
  string(REPLACE "limpid-" "" component ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${component})
  if(NOT TARGET limpid::${component})
    add_library(limpid::${component} ALIAS ${library})
  endif()
endforeach()
install(TARGETS ${LIMPID_LIBRARIES} EXPORT limpid INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(LIMPID_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/limpid)
set(LIMPID_SHADER_DIR ${CMAKE_INSTALL_DATADIR}/limpid/shaders)
install(EXPORT limpid NAMESPACE limpid:: FILE limpidTargets.cmake DESTINATION ${LIMPID_PACKAGE_DIR})
configure_package_config_file(cmake/limpidConfig.cmake.in ${CMAKE_BINARY_DIR}/generated/limpidConfig.cmake
  INSTALL_DESTINATION ${LIMPID_PACKAGE_DIR} PATH_VARS LIMPID_SHADER_DIR NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/limpidConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/limpidConfig.cmake ${CMAKE_BINARY_DIR}/generated/limpidConfigVersion.cmake
  DESTINATION ${LIMPID_PACKAGE_DIR})
install(FILES shaders/limpid/limpid_caustics.glsl DESTINATION ${LIMPID_SHADER_DIR})

file(RELATIVE_PATH LIMPID_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" LIMPID_PC_PREFIX ${LIMPID_PC_PREFIX})
if(LIMPID_IMAGES STREQUAL "lite")
  set(LIMPID_PC_IMAGES "stb zlib")
  set(LIMPID_PC_IMAGE_LIBS " -ltinyexr")
else()
  set(LIMPID_PC_IMAGES OpenImageIO)
endif()
foreach(package limpid limpid-io)
  configure_file(cmake/${package}.pc.in ${CMAKE_BINARY_DIR}/generated/${package}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/generated/${package}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

set(shell ${CMAKE_BINARY_DIR}/generated/shell)
file(MAKE_DIRECTORY ${shell})
add_custom_command(OUTPUT ${shell}/limpid.1 ${shell}/limpid
  COMMAND limpid-program man > ${shell}/limpid.1
  COMMAND limpid-program completion > ${shell}/limpid
  DEPENDS limpid-program VERBATIM)
add_custom_target(limpid-shell ALL DEPENDS ${shell}/limpid.1 ${shell}/limpid)
install(TARGETS limpid-program)
install(FILES ${shell}/limpid.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${shell}/limpid DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Writes every shader of the given folders as a string literal into one C++ source, named by its path from shaders/: see
# gl/ShaderLibrary.h.
function(limpid_embed_shaders OUTPUT)
  set(files)
  foreach(folder ${ARGN})
    file(GLOB_RECURSE found CONFIGURE_DEPENDS
      ${folder}/*.glsl ${folder}/*.vert ${folder}/*.tesc ${folder}/*.tese ${folder}/*.geom ${folder}/*.frag
      ${folder}/*.comp)
    list(APPEND files ${found})
  endforeach()
  add_custom_command(OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${OUTPUT} -DROOT=${CMAKE_SOURCE_DIR}/shaders "-DFILES=${files}"
            -P ${CMAKE_SOURCE_DIR}/cmake/WriteEmbeddedShaders.cmake
    DEPENDS ${files} ${CMAKE_SOURCE_DIR}/cmake/WriteEmbeddedShaders.cmake
    COMMENT "Embedding shaders" VERBATIM)
endfunction()

# Writes every file of shaders/ as a string literal into one C++ source: see gl/ShaderLibrary.h.
function(limpid_embed_shaders OUTPUT)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS
    ${CMAKE_SOURCE_DIR}/shaders/*.glsl ${CMAKE_SOURCE_DIR}/shaders/*.vert ${CMAKE_SOURCE_DIR}/shaders/*.tesc
    ${CMAKE_SOURCE_DIR}/shaders/*.tese ${CMAKE_SOURCE_DIR}/shaders/*.geom ${CMAKE_SOURCE_DIR}/shaders/*.frag
    ${CMAKE_SOURCE_DIR}/shaders/*.comp)
  add_custom_command(OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${OUTPUT} -DROOT=${CMAKE_SOURCE_DIR}/shaders "-DFILES=${files}"
            -P ${CMAKE_SOURCE_DIR}/cmake/WriteEmbeddedShaders.cmake
    DEPENDS ${files} ${CMAKE_SOURCE_DIR}/cmake/WriteEmbeddedShaders.cmake
    COMMENT "Embedding shaders" VERBATIM)
endfunction()

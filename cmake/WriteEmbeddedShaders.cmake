# Run by EmbedShaders.cmake with OUTPUT, ROOT and FILES.
set(text "#include \"gl/ShaderLibrary.h\"\n\nnamespace limpid::gl {\nstd::span<const EmbeddedShader> embeddedShaders() {\n    static constexpr EmbeddedShader shaders[] = {\n")
foreach(file ${FILES})
  file(RELATIVE_PATH name ${ROOT} ${file})
  file(READ ${file} content)
  string(APPEND text "        {\"${name}\", R\"__glsl__(${content})__glsl__\"},\n")
endforeach()
string(APPEND text "    };\n    return shaders;\n}\n} // namespace limpid::gl\n")
file(WRITE ${OUTPUT} "${text}")

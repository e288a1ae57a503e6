# Keeps the build with sanitizers short (the preset builds in batches, and optimizes a little). Clang's time goes into
# headers; and optimizing pays only where CPU tests and fuzz targets spend theirs, in what reads files and what traces
# light.
file(GLOB drawing CONFIGURE_DEPENDS src/gl/*.cpp src/water/*.cpp src/levelmap/*.cpp src/caustics/*.cpp
  src/godrays/*.cpp src/view/*.cpp src/engine/*.cpp)
set_source_files_properties(${drawing} PROPERTIES COMPILE_OPTIONS -O0) # which also keeps them out of batches
foreach(target limpid-program limpid-viewer)
  if(TARGET ${target})
    target_compile_options(${target} PRIVATE -O0)
  endif()
endforeach()

# Names in these stand for something else in their neighbours.
set_source_files_properties(src/io/gltf/Views.cpp src/io/bake/BakedFolderReader.cpp
  src/apps/viewer/MapImages.cpp src/apps/viewer/MeasurePanel.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# Writes public headers (HEADERS, relative to ROOT) below OUTPUT/limpid, their includes of each other with limpid/ in front;
# apps/viewer/ becomes limpid/viewer/.
file(REMOVE_RECURSE ${OUTPUT})
foreach(header ${HEADERS})
  file(READ ${ROOT}/${header} text)
  string(REGEX REPLACE "(#include \")(core|scene|io|reference)/" "\\1limpid/\\2/" text "${text}")
  string(REGEX REPLACE "^(limpid|apps)/" "" place ${header})
  file(WRITE ${OUTPUT}/limpid/${place} "${text}")
endforeach()

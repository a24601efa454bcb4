# cmake -DFILE=... -DTEMPLATE=... -DOUTPUT=... -P EmbedBytes.cmake: writes a file's bytes into a template, for @BYTES@.
file(READ ${FILE} bytes HEX)
string(REGEX REPLACE "(..)" "\\\\x\\1" BYTES "${bytes}")
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
file(TOUCH ${OUTPUT})

# cmake -DFILES=<file>;… -DOUTPUT=<file> -P join.cmake
# Writes a source that includes the given ones, each in a namespace of its own, so that what they have in common
# is compiled once. Their headers come first: inside the namespaces they are guarded against coming again.

set(headers "")
set(bodies "")
foreach(file IN LISTS FILES)
    get_filename_component(stem ${file} NAME_WE)
    get_filename_component(folder ${file} DIRECTORY)
    file(STRINGS ${file} includes REGEX "^#include")
    list(TRANSFORM includes REPLACE "\"(.*)\"" "\"${folder}/\\1\"")
    list(APPEND headers ${includes})
    string(APPEND bodies "\nnamespace joined_${stem} {\n#include \"${file}\"  // NOLINT(bugprone-suspicious-include)\n}\n")
endforeach()
list(REMOVE_DUPLICATES headers)
list(JOIN headers "\n" headers)
file(WRITE ${OUTPUT} "${headers}\n${bodies}")

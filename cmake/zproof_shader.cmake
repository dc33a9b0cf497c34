# zproof_shader(source name [definition]): NAME.h beside the source's place in the build folder, an array NAME of the shader's
# SPIR-V. What is made is listed in shader_headers.
function(zproof_shader source name)
    list(TRANSFORM ARGN PREPEND -D OUTPUT_VARIABLE definitions)
    get_filename_component(folder ${CMAKE_CURRENT_BINARY_DIR}/${source} DIRECTORY)
    set(header ${folder}/${name}.h)
    add_custom_command(OUTPUT ${header} DEPENDS ${source}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
        COMMAND ${ZPROOF_GLSLANG} --quiet -V ${definitions} --vn ${name} -o ${header} ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    set(shader_headers ${shader_headers} ${header} PARENT_SCOPE)
endfunction()

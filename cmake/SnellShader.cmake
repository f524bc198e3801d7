# Compile a compute entry point to SPIR-V and validate it, in every build.
find_program(GLSLC glslc REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

# snell_shader(target source): adds <binary dir>/<name>.spv to the target's build.
function(snell_shader target source)
  get_filename_component(name ${source} NAME)
  get_filename_component(path ${source} ABSOLUTE)
  set(spirv ${CMAKE_CURRENT_BINARY_DIR}/${name}.spv)
  add_custom_command(
    OUTPUT ${spirv}
    COMMAND ${GLSLC} --target-env=vulkan1.2 -O0 -Werror -I ${PROJECT_SOURCE_DIR}/src
            -MD -MF ${spirv}.d -o ${spirv} ${path}
    COMMAND ${SPIRV_VAL} --target-env vulkan1.2 --scalar-block-layout ${spirv}
    DEPENDS ${path}
    DEPFILE ${spirv}.d
    COMMENT "Compiling shader ${name}"
    VERBATIM)
  target_sources(${target} PRIVATE ${spirv})
endfunction()

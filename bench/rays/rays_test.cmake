# Checks the program's tables and exit codes: cmake -DPROGRAM=... -P rays_test.cmake
function(expect code pattern)
  execute_process(COMMAND ${PROGRAM} ${ARGN}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT result EQUAL code)
    message(FATAL_ERROR "snell-rays ${ARGN}: exit code ${result}, expected ${code}\n${output}${errors}")
  endif()
  set(output "${errors}${output}")
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "snell-rays ${ARGN}: no '${pattern}' in\n${output}")
  endif()
endfunction()

set(number "[0-9.]+")
set(ratio "${number} \\[${number}–${number}\\]")
set(small --triangles 3000 --rays 2000 --repetitions 1)
string(CONCAT tables
  "## Million rays per second, 1 thread\n.*"
  "\n\\| instances +\\| second +\\| any +( \\| +${number})+ +\\| +\\| +${ratio} \\| +${ratio} \\|\n.*"
  "Fast: smallest ${number} \\(.*High: smallest ${number} .* geometric mean ${number}\\.\n.*"
  "## Builds\n.*\\| Embree high +\\|.*"
  "## Disagreements\n.*"
  "disagrees with brute force on 0 of [0-9,]+ rays, with itself on 0\\.\n$")

expect(0 "${tables}" ${small} --check 50 --threads 1)
expect(0 "## Growth\n.*\\| height field \\| Embree medium \\|" ${small} --growth)
expect(0 "--repetitions .*--growth" --help)
expect(2 "no scene 'hare'; known are sphereflake, " --scenes hairball,hare)
expect(2 "no kind of rays 'light'; known are primary, " --kinds light)
expect(2 "between 1 and [0-9]+, not 0" --threads 0)
expect(2 "no-such-file.ply" no-such-file.ply)
expect(2 "--speed" --speed)

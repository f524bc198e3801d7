# SPDX-License-Identifier: Apache-2.0
#
# Reads ctest's JUnit file; prints the skipped tests with their reasons, and then one line:
# "N tests ran: P passed, F failed, S skipped". The last step of ./test.
#
# ctest says "notrun" of a test that skipped itself, whose cause then begins with SKIP_, and of one
# that could not be started, which is a failure. The reason of a skip is what GoogleTest prints
# between "Skipped" and "[  SKIPPED ]"; of any other test it is the last line of its output.

function Decoded(text) {
  gsub(/&lt;/, "<", text)
  gsub(/&gt;/, ">", text)
  gsub(/&quot;/, "\"", text)
  gsub(/&apos;/, "'", text)
  gsub(/&amp;/, "\\&", text)
  return text
}

function Attribute(name,    text) {
  text = substr($0, index($0, " " name "=\"") + length(name) + 3)
  return Decoded(substr(text, 1, index(text, "\"") - 1))
}

/^\t<testcase / {
  name = Attribute("name")
  status = Attribute("status")
  cause = reason = lastLine = ""
}

/^\t\t<skipped / { cause = Attribute("message") }

# Look for the reason in the test's output.
sub(/^\t\t<system-out>/, "") { inOutput = 1 }
inOutput {
  isLast = sub(/<\/system-out>$/, "")
  line = Decoded($0)
  if (line ~ /^\[  SKIPPED \]/) inReason = 0
  if (inReason) reason = reason (reason == "" ? "" : " ") line
  if (line ~ /: Skipped$/) inReason = 1
  if (line ~ /[^ \t]/) lastLine = line
  if (isLast) inOutput = inReason = 0
}

/^\t<\/testcase>/ {
  if (status == "run") {
    ++passed
  } else if (status == "disabled" || cause ~ /^SKIP_/) {
    if (reason == "" && cause != "SKIP_REGULAR_EXPRESSION_MATCHED") reason = lastLine
    if (!skipped++) print "\nSkipped:"
    print "  " name ": " (reason == "" ? "no reason given" : reason)
  } else {
    ++failed
  }
}

END {
  total = passed + failed + skipped
  if (!total) exit
  printf "\n%d tests ran: %d passed, %d failed, %d skipped\n", total, passed, failed, skipped
}

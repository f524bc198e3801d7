// SPDX-License-Identifier: Apache-2.0
#include "cli/man_page.h"

#include <fmt/format.h>

#include "api/snell.h"

namespace snell::cli {

namespace {

// Text as roff shows it unchanged: backslashes and hyphens escaped, no line taken for a request.
std::string Escape(const std::string& text) {
  std::string escaped;
  bool lineBegins = true;
  for (const char c : text) {
    if (lineBegins && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
    lineBegins = c == '\n';
  }
  return escaped;
}

// "\fB\-o\fR, \fB\-\-output\fR \fIFILE\fR"
std::string StyledHeading(const Argument& argument) {
  std::string heading;
  for (const std::string& name : argument.names)
    heading += fmt::format("{}\\fB{}\\fR", heading.empty() ? "" : ", ", Escape(name));
  if (!argument.value.empty()) {
    const char style = argument.words.empty() ? 'I' : 'B';
    heading +=
        fmt::format("{}\\f{}{}\\fR", heading.empty() ? "" : " ", style, Escape(argument.value));
  }
  return heading;
}

std::string Paragraph(const std::string& text) {
  if (text.starts_with(' ')) return ".PP\n.nf\n" + Escape(text) + "\n.fi\n";
  return ".PP\n" + Escape(text) + "\n";
}

std::string Entry(const Argument& argument) {
  return ".TP\n" + StyledHeading(argument) + "\n" + Escape(argument.text) + "\n";
}

std::string CommandSection(const Command& command) {
  std::string section =
      fmt::format(".SS \"{}\"\n{}.\n", Escape(command.Synopsis()), Escape(command.summary));
  for (const std::string& paragraph : command.details) section += Paragraph(paragraph);
  for (const Argument& argument : command.Positionals()) section += Entry(argument);
  for (const std::string& group : command.Groups())
    for (const Argument& argument : command.OptionsIn(group)) section += Entry(argument);
  return section;
}

// What no single command tells.
constexpr const char* CommonSections = R"(.SH EXIT STATUS
.TP
.B 0
Success.
.TP
.B 1
A file, a device or the memory is at fault; or a picture differs by more than the tolerance.
.TP
.B 2
The command line is wrong.
.TP
.B 129, 130, 143
Stopped by SIGHUP, SIGINT (Ctrl\-C) or SIGTERM. A render writes what it has before it ends; a second
signal ends it at once.
.SH ENVIRONMENT
.TP
.B SNELL_ISA
The instruction set of the ray traversal:
.BR portable ,
.BR sse4.2 ,
.B avx2
or
.BR avx512 .
Without it, the best one that the processor runs is used. All of them give the same picture.
.TP
.B TMPDIR
Where pictures are rescued to if neither their own folder nor the current one can be written.
)";

}  // namespace

std::string ManPage(const Definitions& definitions) {
  std::string page = fmt::format(".TH SNELL 1 \"\" \"Snell {}\" \"User Commands\"\n", Version());
  page += ".SH NAME\nsnell \\- " + Escape(definitions.program.summary) + "\n";

  // Synopsis and what the program is
  page += ".SH SYNOPSIS\n";
  for (const Command& command : definitions.commands)
    page += fmt::format("{}.br\n", "\\fB" + Escape(command.Synopsis()) + "\\fR\n");
  std::string description, examples;
  for (const std::string& paragraph : definitions.program.details)
    (paragraph.starts_with(' ') ? examples : description) += Paragraph(paragraph);
  page += ".SH DESCRIPTION\n" + description;

  page += ".SH COMMANDS\n";
  for (const Command& command : definitions.commands) page += CommandSection(command);
  page += ".SH OPTIONS\n";
  for (const Argument& argument : definitions.program.arguments) page += Entry(argument);
  return page + CommonSections + ".SH EXAMPLES\n" + examples;
}

}  // namespace snell::cli

# Writes the manual page FILE of palpate-viewer from what PROGRAM --help and --version print.
execute_process(COMMAND "${PROGRAM}" --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${PROGRAM}" --version OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY
  OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REPLACE "${PROGRAM}" "palpate-viewer" help "${help}")
string(REPLACE "\\" "\\e" help "${help}")
string(REPLACE "-" "\\-" help "${help}")
string(REGEX REPLACE "\n([.'])" "\n\\\\&\\1" help "${help}")
file(WRITE "${FILE}" ".TH PALPATE\\-VIEWER 1 \"\" \"${version}\" \"User Commands\"
.SH NAME
palpate\\-viewer \\- see and touch organs in volumes and segmentations
.SH SYNOPSIS AND OPTIONS
.nf
${help}.fi
.SH SEE ALSO
\\fBpalpate\\fR(1)
")

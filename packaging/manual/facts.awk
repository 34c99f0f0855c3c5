# Reads the help of a program, one command after the other, each after a line "@ COMMAND", and prints its content as
# fields separated by tabs:
#   about COMMAND TEXT             usage COMMAND TEXT           command NAME TEXT        note COMMAND LINE
#   argument COMMAND VALUE KIND TEXT
#   option COMMAND NAMES VALUE KIND CHOICES REMARK TEXT
# KIND is the kind of value to complete: session, record, report, file, folder or effect.
BEGIN { OFS = "\t" }

/^@ / { if (count) read_help(); command = $2; count = 0; next }
{ lines[++count] = $0 }
END { if (count) read_help() }

function read_help(   i, line, section, blank, written) {
  section = "head"
  written = 0
  for (i = 1; i <= count; ++i) {
    line = lines[i]
    if (line ~ /^(Positionals|Options|Subcommands|Arguments):$/) { section = line; continue }
    if (line == "") { if (section ~ /:$/) section = "between"; else if (written) blank = 1; continue }
    if (line ~ /^Usage: /) { sub(/^Usage: ([^ ]*\/)?/, "", line); print "usage", command, line; continue }
    if (section == "head") { print "about", command, line; continue }
    if (section == "between") section = "note"
    if (section == "note") {
      if (blank && written) print "note", command, ""
      print "note", command, line
      blank = 0
      written = 1
      continue
    }
    i = read_entry(i, section)
  }
}

# An entry: two blanks, the typed text, blanks, and the meaning, which may continue on the following lines.
function read_entry(i, section,   line, typed, meaning, goes_on) {
  line = substr(lines[i], 3)
  if (match(line, /   */)) { typed = substr(line, 1, RSTART - 1); meaning = substr(line, RSTART + RLENGTH) }
  else if (lines[i + 1] ~ /^          / || length(line) < 28) { typed = line; meaning = "" }
  else { typed = substr(line, 1, 27); meaning = substr(line, 29) }
  while (i < count && lines[i + 1] ~ /^          /) {
    goes_on = lines[++i]
    sub(/^ +/, "", goes_on)
    meaning = meaning (meaning == "" ? "" : " ") goes_on
  }
  if (section == "Subcommands:") print "command", typed, meaning
  else if (typed ~ /^-/) print_option(typed, meaning)
  else print_argument(typed, meaning)
  return i
}

function kind_of(meaning) {
  if (meaning ~ /\*\.alidade-instrument/) return "record"
  if (meaning ~ /\*\.alidade-effect/) return "file"
  if (meaning ~ /a folder with/) return "folder"
  if (meaning ~ /^Files? |^Folder of|^Session to open|^Truth file/) return "file"
  if (meaning ~ /\*\.alidade|^Session whose/) return "session"
  if (meaning ~ /acceptance report/) return "report"
  if (meaning ~ /^NAME=VALUE of an effect/) return "effect"
  return "-"
}

function print_argument(typed, meaning) {
  sub(/ TEXT/, "", typed)
  sub(/ REQUIRED/, "", typed)
  print "argument", command, typed, kind_of(meaning), meaning
}

function print_option(typed, meaning,   names, rest, choices, remark, list) {
  gsub(/, -/, ",-", typed)
  names = typed
  sub(/ .*/, "", names)
  rest = substr(typed, length(names) + 2)
  sub(/\{.*/, "", names)
  remark = ""
  if (rest ~ / ?REQUIRED/) { remark = remark " Required."; sub(/ ?REQUIRED/, "", rest) }
  if (match(rest, / ?Needs: .*/)) { remark = remark " Only with " listed(substr(rest, RSTART, RLENGTH)) "."; rest = substr(rest, 1, RSTART - 1) }
  if (match(rest, / ?Excludes: .*/)) { remark = remark " Not with " listed(substr(rest, RSTART, RLENGTH)) "."; rest = substr(rest, 1, RSTART - 1) }
  choices = ""
  if (match(rest, /:\{[^}]*\}/)) {
    choices = substr(rest, RSTART + 2, RLENGTH - 3)
    gsub(/,/, " ", choices)
    rest = substr(rest, 1, RSTART - 1) substr(rest, RSTART + RLENGTH)
  }
  if (match(rest, /=[^ ]*/)) { remark = " Default: " substr(rest, RSTART + 1, RLENGTH - 1) "." remark; rest = substr(rest, 1, RSTART - 1) substr(rest, RSTART + RLENGTH) }
  gsub(/[<>]/, "", rest)
  if (choices == "" && match(meaning, /: [a-z][A-Za-z_]* or [a-z][A-Za-z_]*\. /)) {
    choices = substr(meaning, RSTART + 2, RLENGTH - 4)
    sub(/ or /, " ", choices)
  }
  sub(/^ /, "", remark)
  print "option", command, names, rest == "" ? "-" : rest, kind_of(meaning), choices == "" ? "-" : choices, remark == "" ? "-" : remark, meaning
}

function listed(text) {
  sub(/^ ?[A-Za-z]*: /, "", text)
  gsub(/ /, ", ", text)
  return text
}

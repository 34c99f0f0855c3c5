# page.awk VERSION= DATE= FACTS PAGE.in: the man page, with the output of facts.awk in place of @OPTIONS@ and @COMMANDS@.
BEGIN { FS = "\t" }

FNR == NR {
  if ($1 == "command") commands[++command_count] = $2
  else if ($1 == "about") about[$2] = $3
  else if ($1 == "usage") usage[$2] = $3
  else if ($1 == "note") notes[$2] = notes[$2] plain($3) "\n"
  else if ($1 == "argument") entries[$2] = entries[$2] ".TP\n.I " plain($3) "\n" sentence($5) "\n"
  else if ($1 == "option") entries[$2] = entries[$2] ".TP\n" typed($3, $4) "\n" sentence($8) choices($6) remark($7) "\n"
  next
}
$0 == "@OPTIONS@" { printf "%s", entries["-"]; next }
$0 == "@COMMANDS@" {
  for (i = 1; i <= command_count; ++i) print_command(commands[i])
  next
}
{ gsub(/@VERSION@/, VERSION); gsub(/@DATE@/, DATE); print }

function print_command(name) {
  print ".SS " plain(usage[name])
  print sentence(about[name])
  printf "%s", entries[name]
  if (name in notes) printf ".PP\n.nf\n%s.fi\n", notes[name]
}

# The text, with all characters escaped that roff would interpret.
function plain(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  gsub(/'/, "\\(aq", text)
  gsub(/`/, "\\(ga", text)
  gsub(/\^/, "\\(ha", text)
  gsub(/~/, "\\(ti", text)
  sub(/^\./, "\\\\\\&.", text)
  return text
}

function sentence(text) {
  text = plain(text)
  return text ~ /[.!?]$/ ? text : text "."
}

function typed(names, value,   parts, count, i, text) {
  count = split(names, parts, ",")
  text = ""
  for (i = 1; i <= count; ++i) text = text (i > 1 ? ", " : "") "\\fB" plain(parts[i]) "\\fR"
  sub(/ x [0-9]+$/, "", value)
  return text (value == "-" ? "" : " \\fI" plain(value) "\\fR")
}

function choices(list) {
  if (list == "-") return ""
  gsub(/ /, ", ", list)
  return "\nOne of: " plain(list) "."
}

function remark(text) { return text == "-" ? "" : "\n" plain(text) }

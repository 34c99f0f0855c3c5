# zsh.awk PROGRAM= FACTS: completion for zsh.
BEGIN { FS = "\t" }

$1 == "command" { commands[++command_count] = $2; about[$2] = $3 }
$1 == "note" && $2 == "simulate" && match($3, /^  [a-z_]+=/) {
  effects = effects (effects == "" ? "" : " ") substr($3, 3, RLENGTH - 2)
}
$1 == "argument" { last[$2] = quoted(($3 ~ /\.\.\./ ? "*" : "1") ":" described($3) action($4, "-")) }
$1 == "option" {
  count = split($3, names, ",")
  for (i = 1; i <= count; ++i) {
    takes_value = $4 != "-"
    entries[$2] = entries[$2] " \\\n    " quoted((takes_value ? "*" : "") names[i] (takes_value && names[i] ~ /^--/ ? "=" : "") \
      "[" bracketed($8) "]" (takes_value ? ":" described($4) action($5, $6) : ""))
  }
}

END {
  name = PROGRAM
  gsub(/-/, "_", name)
  print "#compdef " PROGRAM
  print ""
  for (i = 1; i <= command_count; ++i) {
    command = commands[i]
    print "_" name "_" command "() {"
    gsub(/@EFFECTS@/, effects, entries[command])
    print "  _arguments" entries[command] (command in last ? " \\\n    " last[command] : "")
    print "}"
    print ""
  }
  print "_" name "() {"
  if (command_count) {
    print "  local -a commands=("
    for (i = 1; i <= command_count; ++i) print "    " quoted(commands[i] ":" about[commands[i]])
    print "  )"
    print "  if ((CURRENT > 2)) && ((${commands[(I)${words[2]}:*]})); then"
    print "    local command=${words[2]}"
    print "    shift words"
    print "    ((CURRENT--))"
    print "    _" name "_$command"
    print "    return"
    print "  fi"
    print "  _arguments" entries["-"] " \\\n    '1:command:{_describe command commands}'"
  } else {
    print "  _arguments" entries["-"] ("-" in last ? " \\\n    " last["-"] : "")
  }
  print "}"
  print ""
  print "_" name " \"$@\""
}

function action(kind, choices) {
  if (choices != "-") return ":(" choices ")"
  if (kind == "session") return ":_files -g \"*.alidade\""
  if (kind == "record") return ":_files -g \"*.alidade-instrument\""
  if (kind == "report") return ":_files -g \"*.pdf\""
  if (kind == "file") return ":_files"
  if (kind == "folder") return ":_files -/"
  if (kind == "effect") return ":compadd -S \"\" -- @EFFECTS@"  # a note after the options lists them
  return ": "
}

function quoted(text) {
  gsub(/'/, "'\\''", text)
  return "'" text "'"
}

function bracketed(text) {
  gsub(/\\/, "\\\\", text)
  gsub(/\]/, "\\]", text)
  gsub(/\[/, "\\[", text)
  return text
}

function described(text) {
  sub(/ x [0-9]+$/, "", text)
  sub(/ \.\.\.$/, "", text)
  gsub(/:/, "\\:", text)
  return tolower(text)
}

# bash.awk PROGRAM= FACTS: completion for bash.
BEGIN { FS = "\t"; commands = "" }

$1 == "command" { commands = commands (commands == "" ? "" : " ") $2 }
$1 == "note" && $2 == "simulate" && match($3, /^  [a-z_]+=/) {
  effects = effects (effects == "" ? "" : " ") substr($3, 3, RLENGTH - 2)
}
$1 == "argument" { values = values "    \"" $2 " \") printf '%s' '@" $4 "' ;;\n" }
$1 == "option" {
  names = $3
  gsub(/,/, " ", names)
  options[$2] = options[$2] (options[$2] == "" ? "" : " ") names
  if (!($2 in seen)) { seen[$2] = 1; order[++count] = $2 }
  if ($4 == "-") next
  labels = ""
  split_count = split($3, parts, ",")
  for (i = 1; i <= split_count; ++i) labels = labels (i > 1 ? " | " : "") "\"" $2 " " parts[i] "\""
  what = $6 != "-" ? $6 : "@" $5
  values = values "    " labels ") printf '%s' '" what "' ;;\n"
}

END {
  name = PROGRAM
  gsub(/-/, "_", name)
  print "# bash completion for " PROGRAM
  print "# shellcheck shell=bash"
  print ""
  print "# The options of a command; of the program itself, \"-\"."
  print "_" name "_options() {"
  print "  case $1 in"
  for (i = 1; i <= count; ++i) print "    " order[i] ") printf '%s' '" options[order[i]] "' ;;"
  print "  esac"
  print "}"
  print ""
  print "# The values of an option or argument of a command: words, or @ and a kind."
  print "_" name "_values() {"
  print "  case \"$1 $2\" in"
  printf "%s", values
  print "  esac"
  print "}"
  print ""
  print "_" name "() {"
  print "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=- values i"
  print "  local commands='" commands "'"
  print "  COMPREPLY=()"
  print "  # An equals sign separates words here."
  print "  if [[ $current == = ]]; then current=; elif [[ $previous == = && $COMP_CWORD -gt 2 ]]; then previous=${COMP_WORDS[COMP_CWORD - 2]}; fi"
  print "  for ((i = 1; i < COMP_CWORD; ++i)); do"
  print "    if [[ \" $commands \" == *\" ${COMP_WORDS[i]} \"* ]]; then command=${COMP_WORDS[i]} && break; fi"
  print "  done"
  print "  values=$(_" name "_values \"$command\" \"$previous\")"
  print "  if [[ -z $values && $current == -* ]]; then"
  print "    mapfile -t COMPREPLY < <(compgen -W \"$(_" name "_options \"$command\")\" -- \"$current\")"
  print "    return"
  print "  fi"
  print "  if [[ -z $values && $command == - && -n $commands ]]; then values=$commands; fi"
  print "  [[ -n $values ]] || values=$(_" name "_values \"$command\" '')"
  print "  case $values in"
  print_files("@session", "-f -X '!*.alidade'", 1)
  print_files("@record", "-f -X '!*.alidade-instrument'", 1)
  print_files("@report", "-f -X '!*.pdf'", 1)
  print_files("@file", "-f", 0)
  print_files("@folder", "-d", 0)
  if (effects != "") {
    print "    @effect)"
    print "      compopt -o nospace 2>/dev/null"
    print "      mapfile -t COMPREPLY < <(compgen -W '" effects "' -- \"$current\")"
    print "      ;;"
  }
  print "    @*) ;;"
  print "    *) mapfile -t COMPREPLY < <(compgen -W \"$values\" -- \"$current\") ;;"
  print "  esac"
  print "}"
  print ""
  print "complete -F _" name " " PROGRAM
}

# Completes files of a kind and, if `also_folders`, the folders that may contain them.
function print_files(kind, what, also_folders) {
  print "    " kind ")"
  print "      compopt -o filenames 2>/dev/null"
  print "      mapfile -t COMPREPLY < <(compgen " what " -- \"$current\"" (also_folders ? "; compgen -d -- \"$current\"" : "") ")"
  print "      ;;"
}

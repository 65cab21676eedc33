# Completion of tektite's commands and options; made from the programs' own declarations. Else files are completed.
_tektite() {
  local word=${COMP_WORDS[COMP_CWORD]} options=
  if [ "$COMP_CWORD" -eq 1 ]; then
    options="@commands@"
  elif [ "${COMP_WORDS[1]}" = help ] || [[ $word == -* ]]; then
    case ${COMP_WORDS[1]} in
      help) options="@commands@" ;;
@cases@
    esac
  fi
  mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
}
complete -o bashdefault -o default -F _tektite tektite

#include "CompletionScript.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace palpate::cli
{
namespace
{
std::string Join(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += text.empty() ? word : separator + word;
  }
  return text;
}

// A single-quoted shell word; the escape of a quote in it depends on the shell.
std::string Quoted(const std::string& text, const std::string& quoteEscape)
{
  std::string result = "'";
  for (const char c : text)
  {
    result += c == '\'' ? quoteEscape : std::string(1, c);
  }
  return result + "'";
}
std::string QuotedForBash(const std::string& text)
{
  return Quoted(text, "'\\''");
}
std::string QuotedForFish(const std::string& text)
{
  return Quoted(text, "\\'");
}

// Brackets and colons in a help text are special in zsh's _arguments.
std::string HelpForZsh(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result +=
        c == '[' || c == ']' || c == ':' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return result;
}
} // namespace

CompletionScript::CompletionScript(const CLI::App& root)
{
  this->Commands.emplace_back(root);
  this->Commands.front().Name.clear();
  for (DeclaredCommand command : DeclaredCommands(root))
  {
    // The program's own options are also accepted after a command.
    for (const DeclaredOption& option : this->Program().Options)
    {
      if (!option.HasName("--help") && !option.HasName("--version"))
      {
        command.Options.push_back(option);
      }
    }
    this->Commands.push_back(std::move(command));
  }
}

std::string CompletionScript::BashWords(const DeclaredCommand& command)
{
  std::vector<std::string> words;
  for (const DeclaredOption& option : command.Options)
  {
    const auto& more = option.Names.empty() ? option.Values : option.Names;
    words.insert(words.end(), more.begin(), more.end());
  }
  return "    '" + command.Name + "') words=" + QuotedForBash(Join(words, " ")) + " ;;\n";
}

std::string CompletionScript::BashValues(const DeclaredCommand& command)
{
  std::string cases;
  for (const DeclaredOption& option : command.Options)
  {
    if (!option.Names.empty() && option.TakesValue())
    {
      cases += "    '" + command.Name + " " + Join(option.Names, "'|'" + command.Name + " ") +
               "') words=" + QuotedForBash(Join(option.Values, " ")) + " ;;\n";
    }
  }
  return cases;
}

std::string CompletionScript::Bash() const
{
  std::string names;
  std::string options;
  std::string values;
  for (const DeclaredCommand& command : this->Commands)
  {
    names += " " + command.Name;
    options += BashWords(command);
    values += BashValues(command);
  }
  return "_palpate()\n{\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local command= words= i\n"
         "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
         "    case ${COMP_WORDS[i]} in\n      -*) ;;\n"
         "      *) command=${COMP_WORDS[i]}; break ;;\n    esac\n  done\n"
         "  case $command in\n" +
         options +
         "  esac\n"
         "  [[ -z $command ]] && words+=" +
         QuotedForBash(names) + "\n  case \"$command $previous\" in\n" + values +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n}\n"
         "# File names if nothing else matches.\n"
         "complete -o default -F _palpate palpate\n";
}

std::string CompletionScript::Zsh() const
{
  std::ostringstream script;
  script << "#compdef palpate\n_palpate()\n{\n  local -a commands\n  commands=(\n";
  for (const DeclaredCommand& command : this->Commands)
  {
    if (!command.Name.empty())
    {
      script << "    " << QuotedForBash(command.Name + ":" + HelpForZsh(command.Help)) << "\n";
    }
  }
  script << "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
         << "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n";
  for (const DeclaredCommand& command : this->Commands)
  {
    if (command.Name.empty())
    {
      continue;
    }
    script << "    " << command.Name << ")\n      _arguments";
    for (const DeclaredOption& option : command.Options)
    {
      const std::string action =
          option.Values.empty() ? "_files" : "(" + Join(option.Values, " ") + ")";
      for (const std::string& name : option.Names)
      {
        script << " \\\n        "
               << QuotedForBash("*" + name + "[" + HelpForZsh(option.Help) + "]" +
                                (option.TakesValue() ? ":value:" + action : ""));
      }
      if (option.Names.empty() && !option.Values.empty())
      {
        script << " \\\n        " << QuotedForBash("1:value:" + action);
      }
    }
    script << " \\\n        '*:file:_files' ;;\n";
  }
  // Loaded by zsh at the first completion, or sourced by the user.
  script << "  esac\n}\nif [[ $funcstack[1] == _palpate ]]; then\n  _palpate \"$@\"\nelse\n"
         << "  compdef _palpate palpate\nfi\n";
  return script.str();
}

std::string CompletionScript::Fish() const
{
  std::ostringstream script;
  for (const DeclaredCommand& command : this->Commands)
  {
    const std::string when = command.Name.empty() ? "__fish_use_subcommand"
                                                  : "__fish_seen_subcommand_from " + command.Name;
    if (!command.Name.empty())
    {
      script << "complete -c palpate -n __fish_use_subcommand -a " << command.Name << " -d "
             << QuotedForFish(command.Help) << "\n";
    }
    for (const DeclaredOption& option : command.Options)
    {
      script << "complete -c palpate -n " << QuotedForFish(when);
      for (const std::string& name : option.Names)
      {
        script << (name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1));
      }
      script << (option.TakesValue() && !option.Names.empty() ? " -r" : "");
      if (!option.Values.empty())
      {
        script << " -f -a " << QuotedForFish(Join(option.Values, " "));
      }
      script << " -d " << QuotedForFish(option.Help) << "\n";
    }
  }
  return script.str();
}
} // namespace palpate::cli

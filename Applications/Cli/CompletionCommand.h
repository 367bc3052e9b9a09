#pragma once

#include "Command.h"

namespace palpate::cli
{
/// `palpate completion SHELL`: a script with which the shell completes commands, options and the
/// options' fixed values. It is generated from the declared options, so it is never out of date.
class CompletionCommand : public Command
{
public:
  std::string Name() const override { return "completion"; }
  std::string Summary() const override { return "Print a completion script for a shell"; }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  const CLI::App* Root = nullptr;
  std::string Shell;
};
} // namespace palpate::cli

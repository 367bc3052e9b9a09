#pragma once

#include "Command.h"

namespace palpate::cli
{
/// `palpate manual`: the manual page, generated from the declared options; the build installs it.
class ManualCommand : public Command
{
public:
  std::string Name() const override { return "manual"; }
  std::string Summary() const override { return "Print the manual page of all commands"; }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  const CLI::App* Root = nullptr;
};
} // namespace palpate::cli

#pragma once

#include "Command.h"

#include <string>

namespace palpate::cli
{
/// `palpate devices`: the kinds of devices of this build and what each says of itself.
class DevicesCommand : public Command
{
public:
  std::string Name() const override { return "devices"; }
  std::string Summary() const override
  {
    return "List the haptic devices that can be used, and what stands in their way";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  bool Json = false;
};
} // namespace palpate::cli

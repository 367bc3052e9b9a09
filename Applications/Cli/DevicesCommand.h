#pragma once

#include "Command.h"

#include <string>

namespace palpate::cli
{
/// `palpate devices`: the kinds of devices of this build and what each says of itself; and homing
/// one, with its loop measured.
class DevicesCommand : public Command
{
public:
  std::string Name() const override { return "devices"; }
  std::string Summary() const override
  {
    return "List the haptic devices that can be used and what stands in their way, or home one";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  int List(Console& console) const;
  int Home(Console& console) const;

  bool Json = false;
  bool IsHoming = false;
  std::string Device;
  std::string Firmware;
};
} // namespace palpate::cli

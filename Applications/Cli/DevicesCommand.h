#pragma once

#include "Command.h"

#include <string>

namespace palpate::cli
{
/// `palpate devices`: lists the kinds of devices of this build with their status; or homes one and
/// measures its loop.
class DevicesCommand : public Command
{
public:
  std::string Name() const override { return "devices"; }
  std::string Summary() const override
  {
    return "List haptic devices and what prevents their use, or home one";
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

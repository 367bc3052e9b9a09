#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// The kinds of devices that a program knows, by name. An ordinary object: whoever composes the
/// program fills it and hands it on.
class DeviceRegistry
{
public:
  /// Makes a closed device. `argument` says which one where a kind needs telling (a file, a serial
  /// number); the clock outlives the device.
  using Factory = std::function<Status(Clock& clock, const std::string& argument,
                                       std::unique_ptr<HapticDevice>& device)>;

  /// Refuses an empty name, one that is taken, and an empty factory.
  Status Add(const std::string& name, const std::string& description, Factory factory);

  /// In the order of their being added.
  std::vector<std::string> Names() const;
  /// Empty for a name that is not known.
  std::string Description(const std::string& name) const;
  /// `text` is "name" or "name:argument". Fails, naming what there is, for a name that is not
  /// known.
  Status Make(const std::string& text, Clock& clock, std::unique_ptr<HapticDevice>& device) const;

private:
  struct Kind
  {
    std::string Name;
    std::string Description;
    Factory MakeDevice;
  };
  const Kind* Find(const std::string& name) const;

  std::vector<Kind> Kinds;
};
} // namespace palpate

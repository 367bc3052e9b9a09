#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A device found by a search.
struct FoundDevice
{
  std::string Argument;  ///< for the factory of its kind
  bool IsUsable = false; ///< it can be opened in its current state
  std::string Details;   ///< its state, or what prevents its use
  /// What it answered while it was open; none: what is known of its kind.
  std::optional<DeviceCapabilities> Capabilities = std::nullopt;
};

/// Kinds of devices that a program supports, by name. Not a global: the program creates, fills and
/// passes it.
class DeviceRegistry
{
public:
  /// Creates a closed device. `argument` selects one if the kind requires it (a file, a serial
  /// number); the clock outlives the device.
  using Factory = std::function<Status(Clock& clock, const std::string& argument,
                                       std::unique_ptr<HapticDevice>& device)>;

  /// Searches for connected devices of a kind, without changing their state. For kinds that take a
  /// while to open.
  using Search = std::function<Status(Clock& clock, std::vector<FoundDevice>& found)>;

  /// What a back end has proved itself on.
  enum class Proof
  {
    Done,              ///< on the device itself, or there is none
    UntriedOnHardware, ///< on a virtual device only
  };

  struct Kind
  {
    std::string Name;
    std::string Description;
    Factory MakeDevice;
    Search FindDevices; ///< null: devices of this kind need not be plugged in
    Proof ProvedBy = Proof::Done;
  };

  /// Fails for an empty or duplicate name, and an empty factory.
  Status Add(const std::string& name, const std::string& description, Factory factory,
             Search search = nullptr, Proof proof = Proof::Done);

  /// In the order of Add.
  const std::vector<Kind>& Kinds() const noexcept { return this->Known; }
  /// Null for an unknown name.
  const Kind* Find(const std::string& name) const;
  /// `text` is "name" or "name:argument". For an unknown name it fails, listing the known ones.
  Status Make(const std::string& text, Clock& clock, std::unique_ptr<HapticDevice>& device) const;

private:
  std::vector<Kind> Known;
};
} // namespace palpate

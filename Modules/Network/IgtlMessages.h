#pragma once

#include "IndexedMesh.h"
#include "PlainVector3.h"

#include <cstdint>
#include <string>
#include <vector>

// OpenIGTLink messages ready to be sent, with the present time.
namespace palpate
{
/// A SENSOR message of three newtons.
std::vector<std::uint8_t> IgtlForceMessage(const std::string& name, const PlainVector3& force);
/// A TRANSFORM message of a place without a turn. The place (mm, LPS) is sent in RAS, as other
/// programs expect it of the patient.
std::vector<std::uint8_t> IgtlPlaceMessage(const std::string& name, const PlainVector3& placeWorld);
/// A STRING message `Event`.
std::vector<std::uint8_t> IgtlEventMessage(const std::string& text);
/// A POLYDATA message of triangles (mm, LPS), sent in RAS. Of the name 20 characters arrive.
std::vector<std::uint8_t> IgtlSurfaceMessage(const std::string& name, const IndexedMesh& surface);
} // namespace palpate

#pragma once

#include "UsbfsFalcon.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <umockdev.h>

namespace palpate::test
{
struct ObjectReleaser
{
  void operator()(void* object) const { g_object_unref(object); }
};
template <typename Object>
using ObjectPointer = std::unique_ptr<Object, ObjectReleaser>;

/// The usbfs node of a virtual Falcon in a umockdev test bed: answers requests of other programs.
/// The node is a named pipe with one slot, writable while there is something to reap, so that
/// programs sleep in poll as they do on usbfs.
class UmockdevNode
{
public:
  /// Creates the node at `path` (below /dev). Keeps the addresses.
  UmockdevNode(UMockdevTestbed* bed, UsbfsFalcon& falcon, std::string path);
  ~UmockdevNode();
  UmockdevNode(const UmockdevNode&) = delete;
  UmockdevNode& operator=(const UmockdevNode&) = delete;

  /// Removes the node; programs that have it open are served until this object ends.
  void Remove();
  /// The real path of the pipe.
  const std::string& File() const { return this->Pipe; }

private:
  // Copies of a program's requests, which are written back when they are reaped.
  struct Submitted
  {
    ObjectPointer<UMockdevIoctlData> Urb;
    ObjectPointer<UMockdevIoctlData> Buffer;
  };
  struct Client
  {
    UsbfsFile* File = nullptr;
    bool HasWork = false;
    std::map<void*, Submitted> Urbs; // by address in the program
  };

  // Lets umockdev's thread find the node, which may end while it is in a handler.
  struct Handle
  {
    std::mutex Access;
    UmockdevNode* Node = nullptr; // while it exists
  };

  static gboolean OnRequest(UMockdevIoctlBase* base, UMockdevIoctlClient* client, gpointer handle);
  static void OnConnected(UMockdevIoctlBase* base, UMockdevIoctlClient* client, gpointer handle);
  void Connect(const char* signal, GCallback handler);
  int Answer(Client& client, unsigned long request, UMockdevIoctlData* argument);
  int Submit(Client& client, UMockdevIoctlData* argument);
  int Reap(Client& client, UMockdevIoctlData* argument);
  Client& ClientOf(UMockdevIoctlClient* client);
  void Forget(UMockdevIoctlClient* client);
  void Show(Client& client, bool hasWork);

  UMockdevTestbed* Bed;
  UsbfsFalcon& Falcon;
  std::string Path;
  std::string Pipe;
  int Descriptor = -1;
  int WithWork = 0; // number of clients with something to reap
  bool IsRemoved = false;
  ObjectPointer<UMockdevIoctlBase> Handler;
  std::map<UMockdevIoctlClient*, Client> Clients; // guarded by the handle's mutex
  std::shared_ptr<Handle> Self = std::make_shared<Handle>();
};
} // namespace palpate::test

// SPDX-License-Identifier: Apache-2.0
//
// snell devices: what there is to render on, as a table.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/values.h"
#include "util/json.h"
#include "util/text.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Lists the processor and the GPUs that Vulkan knows, with what each lacks to render. The first "
    "column is what --device of 'snell render' takes; a star marks what it takes by itself.";

struct DevicesArguments {
  bool json = false;
};

std::string TableOf(const DeviceList& list) {
  std::string text;
  for (const DeviceInfo& device : list.devices) {
    text += fmt::format("{} {:<6} {:<11} {:>10}  {}", device.wish == list.automatic ? '*' : ' ',
                        device.wish, device.type, ByteSize(device.memoryBytes), device.name);
    if (!device.driver.empty())
      text += fmt::format("; driver {}, Vulkan {}", device.driver, device.vulkan);
    if (!device.missing.empty()) text += fmt::format("; lacks {}", fmt::join(device.missing, ", "));
    text += '\n';
  }
  if (!list.noGpus.empty()) text += fmt::format("No GPUs: {}\n", list.noGpus);
  return text;
}

std::string JsonOf(const DeviceList& list) {
  JsonWriter json;
  json.BeginArray("devices");
  for (const DeviceInfo& device : list.devices) {
    json.BeginObject("");
    json.Add("device", device.wish);
    json.Add("name", device.name);
    json.Add("type", device.type);
    json.Add("bytes", device.memoryBytes);
    if (!device.driver.empty()) {
      json.Add("driver", device.driver);
      json.Add("vulkan", device.vulkan);
    }
    json.Add("missing", device.missing);
    json.End();
  }
  json.End();
  json.Add("automatic", list.automatic);
  if (!list.noGpus.empty()) json.Add("no_gpus", list.noGpus);
  return json.Finish();
}

int RunDevices(const DevicesArguments& arguments) {
  const DeviceList list = Devices();
  PrintOut(arguments.json ? JsonOf(list) : TableOf(list));
  return Succeeded;
}

}  // namespace

void AddDevicesCommand(Program& program) {
  const auto arguments = std::make_shared<DevicesArguments>();
  CLI::App& command = AddCommand<DevicesArguments>(
      program, "devices", "List what there is to render on", Details, arguments, RunDevices);
  AddFlag(command, "--json", arguments->json, "As JSON");
}

}  // namespace snell::cli

// Reads any text as SAS+: it is refused with an InputError, or what is written of it reads back as the same
// text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "parser/diagnostic.hpp"
#include "search/task/sas.hpp"

namespace {

std::string written(const praxis::FiniteDomainTask& task) {
    std::ostringstream out;
    praxis::write_sas(task, out);
    return out.str();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    praxis::FiniteDomainTask task;
    try {
        task = praxis::read_sas({"fuzz.sas", text});
    } catch (const praxis::InputError&) {
        return 0;
    }
    const std::string once = written(task);
    if (written(praxis::read_sas({"written.sas", once})) != once) std::abort();
    return 0;
}

// The page that the viewer is, without a document; made by web/bundle.js when the project is built.
#pragma once

#include <span>
#include <string_view>

namespace praxis::tamp {

/// Three texts, each in pieces; the title goes between the first and the second, the document between the
/// second and the third.
struct PageTemplate {
    std::span<const std::string_view> before_title;
    std::span<const std::string_view> before_document;
    std::span<const std::string_view> after_document;
};

/// Null in a build without the viewer.
const PageTemplate* page_template();

}  // namespace praxis::tamp

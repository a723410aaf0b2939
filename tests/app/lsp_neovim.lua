-- SPDX-License-Identifier: GPL-3.0-or-later
-- nvim --headless --clean -u NONE -c "luafile lsp_neovim.lua": Neovim's own client with the language server $PROVEOUT_CLI.
-- Opens a program with a fault in line 4, repairs it, and asks about it. Prints "passed", or what was wrong.
local function try()
    vim.cmd("edit part.ngc")
    local client = vim.lsp.start_client({ name = "proveout", cmd = { os.getenv("PROVEOUT_CLI"), "lsp" }, root_dir = vim.fn.getcwd() })
    vim.lsp.buf_attach_client(0, client)
    local function has(code)
        return function()
            for _, one in ipairs(vim.diagnostic.get(0)) do
                if one.code == code or (one.user_data and one.user_data.lsp and one.user_data.lsp.code == code) then
                    return one.lnum == 3
                end
            end
            return false
        end
    end
    assert(vim.wait(20000, has("code-unknown"), 20), "no diagnostic in line 4")
    vim.api.nvim_buf_set_text(0, 3, 0, 3, 4, { "G1" })
    assert(vim.wait(20000, function() return not has("code-unknown")() end, 20), "the diagnostic stays")
    local function ask(method, line, character)
        local parameters = { textDocument = { uri = vim.uri_from_bufnr(0) }, position = { line = line, character = character } }
        local answers = vim.lsp.buf_request_sync(0, method, parameters, 20000)
        return assert(answers and answers[client] and answers[client].result, method .. " has no answer")
    end
    local hover = ask("textDocument/hover", 3, 1).contents.value
    assert(hover:find("straight feed", 1, true), "hover: " .. hover)
    assert(ask("textDocument/definition", 3, 9).range.start.line == 1, "definition")
    local symbols = ask("textDocument/documentSymbol", 0, 0)
    assert(symbols[1].name == "T2" and symbols[1].children[1].name == "pocket", "outline: " .. vim.inspect(symbols))
    vim.lsp.stop_client(client)
end
local ok, reason = pcall(try)
io.stdout:write(ok and "passed\n" or ("failed: " .. tostring(reason) .. "\n"))
vim.cmd("qall!")

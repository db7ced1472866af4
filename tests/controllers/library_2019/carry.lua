-- SPDX-License-Identifier: MIT
-- luacheck: globals Say api package debug
-- A program in the manner of the BuilderBot's library of 2019: modules found by package.path, one of
-- them by a parameter, messages by the file that they come from, nodes of behaviour.
package.path = package.path .. ';Tools/?.lua'
package.path = package.path .. ';Nodes/?.lua;rules/?.lua'
Say = require('Say')
if api == nil then api = require('api') end
local rules = require(robot.params.rules)
local create_pick_up = require('pick_up')

Say.on['pick up'] = true
local behaviour

function init()
   behaviour = create_pick_up { type = rules.type }
   robot.camera_system.enable()
end

function step()
   api.process()
   local running, success = behaviour()
   if not running then Say.on['main'] = true Say(success and 'done' or 'failed') end
end

function reset() end
function destroy() end

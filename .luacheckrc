-- Globals that robots' and blocks' programs find (docs/controllers.md), and callbacks they give.
std = 'lua54'
max_line_length = false
read_globals = { 'log', 'logerr', 'vector2', 'vector3', 'quaternion' }
globals = { 'robot', 'init', 'step', 'reset', 'destroy', 'on_start', 'on_step', 'on_end' }
